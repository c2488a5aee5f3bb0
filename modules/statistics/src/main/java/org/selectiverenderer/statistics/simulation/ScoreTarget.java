package org.selectiverenderer.statistics.simulation;

/**
 * Means and standard deviations that the scores of simulated participants shall have, as a row of
 * the thesis's Tables 6 to 11 prints them for one level of confidence.
 */
public record ScoreTarget(double dPrime, double dPrimeSd, double logBeta, double logBetaSd) {}
