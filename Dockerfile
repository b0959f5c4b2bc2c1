# SPDX-License-Identifier: MIT
# docker build -t daylight .   then   docker run --rm -v "$PWD:/work" daylight gate --plugin ./libmine.so
FROM debian:12 AS build
COPY . /daylight
WORKDIR /daylight
RUN ./daylight --version && ninja -C build/release portable && mkdir /portable && tar -xf build/daylight-*.tar.gz -C /portable --strip-components 1

FROM debian:12-slim
RUN apt-get update && apt-get install -y --no-install-recommends libstdc++6 && rm -rf /var/lib/apt/lists/*
COPY --from=build /portable /opt/daylight
WORKDIR /work
ENTRYPOINT ["/opt/daylight/bin/daylight"]
