/**
 * The replication of the thesis's study by one command: its scene, lists, plan and sessions with
 * simulated participants, the analysis, and the thesis's Tables 3 to 11 and Figs 92 to 98 beside
 * what comes out.
 *
 * <p>In: a folder, the apartment, a number of participants and a seed; as resources what the thesis
 * prints (tables-3-5.csv, tables-6-11.csv of its Tables 3 to 11; kitchen-means.csv of Figs 92 and
 * 96 with the covariance that the error terms of Figs 93 to 98 imply; kitchen-results.csv of these;
 * effects.csv of 6.5). Out: a study with its scenes and sessions, tables and a page. Uses {@code
 * study}, {@code statistics}, {@code polygon}, {@code chart}, {@code formats}, {@code
 * authoring.packaging} and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.app.replication;

import org.jspecify.annotations.NullMarked;
