# The course with everything installed and built, on Debian 12: for students on macOS and Windows
# (docs/containers.md), and for the learning platforms that grade in images.
#
#   docker build -t graphics-course .
FROM debian:12-slim

# The lists of packages have one home; only a change of theirs installs them anew.
COPY scripts /course/scripts
RUN apt-get update \
    && bash -c 'source /course/scripts/packages.sh && DEBIAN_FRONTEND=noninteractive \
        apt-get install -y --no-install-recommends "${build_packages[@]}"' \
    && rm -rf /var/lib/apt/lists/*

# Where a container has no namespaces, submissions run as another user, who is to read nothing here.
WORKDIR /course
COPY . .
RUN chmod 700 /course

# Builds, and draws a picture; 1 means that not all defences are active in a container.
RUN ./grade --yes doctor || [ $? -eq 1 ]

CMD ["bash"]
