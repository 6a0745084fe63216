#!/usr/bin/env bash
# The board that QEMU emulates with a processor:  board.sh CORTEX
case $1 in
  m3) echo mps2-an385 ;;
  m4) echo mps2-an386 ;;
  m7) echo mps2-an500 ;;
  *) echo "unknown processor: $1" >&2 && exit 1 ;;
esac
