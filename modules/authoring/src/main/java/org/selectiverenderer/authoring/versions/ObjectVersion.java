package org.selectiverenderer.authoring.versions;

import java.nio.file.Path;

/**
 * One version of an object.
 *
 * @param number from 1, the original
 * @param file file of the version
 * @param error the largest deviation from the original, as a share of its largest extent; NaN for a
 *     version that was kept as it is
 * @param met whether the goal has been reached
 */
public record ObjectVersion(
    int number, Path file, int vertices, int polygons, double error, boolean met) {}
