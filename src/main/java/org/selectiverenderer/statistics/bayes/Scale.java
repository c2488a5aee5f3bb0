package org.selectiverenderer.statistics.bayes;

/**
 * How large things are in the data of a design, so that integrals look in the right places.
 *
 * @param variance of the error, from what no term explains
 * @param average how many times larger it is in the participants' averages
 */
record Scale(double variance, double average) {}
