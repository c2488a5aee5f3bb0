/**
 * The analysis of a study's trials by its own design: {@link
 * org.selectiverenderer.study.analysis.StudyTrials} is a table of trials, {@link
 * org.selectiverenderer.study.analysis.MeasureOfTrials} computes the values that an analysis
 * compares (response times, shares, d', thresholds of staircases, answers), {@link
 * org.selectiverenderer.study.analysis.TrialAnalyses} has the analyses that the study plans and
 * those that nobody planned, and {@link org.selectiverenderer.study.analysis.PlannedPower}
 * simulates how often the planned ones find what is there.
 */
@NullMarked
package org.selectiverenderer.study.analysis;

import org.jspecify.annotations.NullMarked;
