#!/bin/sh
mkdir -p /grade/results
cd /grade && xnewell grade bench student --rubric tests/rubric --format prairielearn -o results/results.json
