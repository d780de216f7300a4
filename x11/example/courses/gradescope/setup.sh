#!/bin/sh
# Beside it in the zip: run_autograder, the rubric and the Debian package.
apt-get update && apt-get install -y /autograder/source/*.deb
