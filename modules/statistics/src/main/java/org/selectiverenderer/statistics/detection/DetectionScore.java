package org.selectiverenderer.statistics.detection;

/**
 * The signal detection score of a participant for the objects of one type in one area at one
 * confidence level.
 *
 * @param type type of the objects
 * @param objects number of objects that the participant was asked about
 */
public record DetectionScore(
    String participant,
    String condition,
    String area,
    String type,
    ConfidenceThreshold level,
    int objects,
    ResponseCounts counts,
    DetectionIndices detection) {}
