package org.selectiverenderer.validation;

import java.util.List;

/**
 * A file that has been checked by itself.
 *
 * @param findings of the file's own checks
 * @param suppressions by comments in it
 */
record FileResult(FileOutline outline, List<Finding> findings, Suppressions suppressions) {}
