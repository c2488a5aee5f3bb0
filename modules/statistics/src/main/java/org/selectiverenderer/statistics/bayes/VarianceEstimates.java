package org.selectiverenderer.statistics.bayes;

/**
 * Estimates of the variances in the data of a design, which locate the region of integration.
 *
 * @param variance error variance, estimated from the residuals
 * @param average variance of the participants' averages in units of the error variance, at least 1
 */
record VarianceEstimates(double variance, double average) {}
