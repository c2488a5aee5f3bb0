package org.selectiverenderer.statistics.data;

import org.selectiverenderer.base.problem.Location;

/**
 * Something in a file that an analysis does not use, or not fully.
 *
 * @param participant whose it is; empty when unknown
 * @param reason what is wrong and what is done about it
 */
public record Exclusion(Location location, String participant, String reason) {}
