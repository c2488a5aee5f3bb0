package org.selectiverenderer.statistics.data;

import org.selectiverenderer.base.problem.SourceLocation;

/**
 * An item of a data file that an analysis does not use, or uses only in part.
 *
 * @param participant the participant concerned; empty when unknown
 * @param reason what is wrong and how the analysis handles it
 */
public record Exclusion(SourceLocation location, String participant, String reason) {}
