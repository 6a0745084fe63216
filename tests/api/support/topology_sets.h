/* The sets of balls that the topology's tests go through: those of ball_sets.h and more, chosen for their shells,
 * voids, handles and faces with holes, and for special positions of a sphere's highest and lowest point. */
#pragma once

#include "ball_sets.h"

uint32_t topology_set_count(void);

/* Set number `which`, always the same. */
void topology_set_make(uint32_t which, ball_set *set);

/* Calls check(set, probe) for all sets of ball_sets.h and these, with each of the probes. */
void sets_with_probes(const double *probes, uint32_t count, void (*check)(const ball_set *set, double probe));

/* ---- sets with a known topology, by name ---- */

/* Hollow walls of spacing 64, 8 and 1 about the origin, in this order, and a ball of radius 1/8 in the middle. */
void topology_set_nested(ball_set *set);

/* A hollow wall of spacing 8 about the origin, and in its void two balls of radius 1/2 at -1 and 1 on the x axis. */
void topology_set_two_in_a_void(ball_set *set);

/* Two rings of eight balls each, linked. */
void topology_set_linked_rings(ball_set *set);

/* A hollow wall of spacing 1 about (1, 1, 1) with three of its six sides open: genus 2. */
void topology_set_cage(ball_set *set);

/* A block of 67 balls around a ring-shaped cavity: genus 0 outside, 1 inside. */
void topology_set_ring_cavity(ball_set *set);

/* A grid of 5 x 5 x 5 balls along whose cubes' edges balls overlap, not across: 125 - 300 is its Euler number. */
void topology_set_scaffold(ball_set *set);

/* A ball of radius 10 with 30 small ones on it, all apart: one face has 30 holes. */
void topology_set_thirty_on_one(ball_set *set);
