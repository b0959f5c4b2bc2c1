# SPDX-License-Identifier: MIT
"""What robots of scenes/approaches.py have in common: links on links, and which pairs of their solids are checked."""
import collections
import itertools


class Tree:
    """Who is one sets order (links, parents first), parent (by link), solids, shapes (their number by link), disabled
    (of links, each a frozenset)."""

    def joined(self, link):
        """Whether it is fixed to its parent."""
        raise NotImplementedError

    def stands(self, link):
        """Whether it stands on what is there to be hit."""
        return False

    def rigid(self, each_link):
        """By link the first link of its rigid body."""
        first = {}
        for link in self.order:
            first[link] = first[self.parent[link]] if not each_link and self.joined(link) else link
        return first

    def pairs(self, each_link):
        first = self.rigid(each_link)
        solid = {first[link] for link, count in self.shapes.items() if count}
        near = collections.defaultdict(set)  # graph of rigid bodies that joints join
        for link in self.order:
            if link in self.parent and first[link] == link and not self.stands(link):
                parent = first[self.parent[link]]
                near[link].add(parent)
                near[parent].add(link)

        def adjacent(a, b):
            seen, left = {a}, [a]
            while left:
                for c in near[left.pop()] - seen:
                    if c == b:
                        return True
                    seen.add(c)
                    left += [c] * (c not in solid)
            return False

        for i, j in itertools.combinations(range(len(self.solids)), 2):
            one, other = self.solids[i], self.solids[j]
            a, b = one.link, other.link
            if not (one.bits[0] & other.bits[1] or other.bits[0] & one.bits[1]):
                continue
            if first[a] != first[b] and frozenset((a, b)) not in self.disabled and not adjacent(first[a], first[b]):
                yield i, j
