# SPDX-License-Identifier: MIT
"""What robots of scenes/study/approaches.py have in common: links on links, and which pairs of their solids are checked."""
import itertools


class Tree:
    """Who is one sets order (links, parents first), parent (by link), solids, shapes (their number by link), disabled
    (of links, each a frozenset)."""

    welds = False  # as in MuJoCo, links that fixed joints join have the same neighbours

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
        group = self.rigid(each_link or not self.welds)  # by link the first of those with the same neighbours
        solid = {group[link] for link, count in self.shapes.items() if count}

        def carries(a, b):
            """Whether a is the next with shapes below b."""
            while b in self.parent and not self.stands(b):
                before, b = b, self.parent[b]
                if group[b] != group[before] and group[b] in solid:
                    return group[b] == a
            return False

        for i, j in itertools.combinations(range(len(self.solids)), 2):
            one, other = self.solids[i], self.solids[j]
            a, b = one.link, other.link
            if not (one.bits[0] & other.bits[1] or other.bits[0] & one.bits[1]):
                continue
            if first[a] != first[b] and frozenset((a, b)) not in self.disabled and not (
                    carries(group[a], b) or carries(group[b], a)):
                yield i, j
