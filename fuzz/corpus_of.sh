#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints the files of the corpus that a target starts from: records of pairs serve all of these, and one made by cells those
# with a mesh.
# usage: corpus_of.sh TARGET
set -euo pipefail
corpus=$(cd "$(dirname "$0")/corpus" && pwd)
case $1 in
  motion_*) folders=(motions) ;;
  edits | load | response | touch | universe) folders=("$1") ;;
  mesh_* | *_mesh) folders=(pairs meshes) ;;
  *) folders=(pairs) ;;
esac
find "${folders[@]/#/$corpus/}" -type f
