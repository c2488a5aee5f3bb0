package org.selectiverenderer.statistics.detection;

/**
 * A participant's result for the objects of one type in one area at one confidence level.
 *
 * @param type of the objects
 * @param objects asked for
 */
public record Score(
    String participant,
    String condition,
    String area,
    String type,
    ConfidenceLevel level,
    int objects,
    ResponseCounts counts,
    Detection detection) {}
