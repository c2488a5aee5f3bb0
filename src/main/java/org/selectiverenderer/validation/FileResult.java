package org.selectiverenderer.validation;

import java.util.List;

/**
 * A file that has been checked by itself.
 *
 * @param findings of the file's own checks, those that are wanted
 * @param dropped how many more there are
 * @param suppressions by comments in it
 */
record FileResult(
    FileOutline outline, List<Finding> findings, int dropped, Suppressions suppressions) {}
