package org.selectiverenderer.validation.run;

import java.util.List;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.Finding;

/**
 * A file that has been checked by itself.
 *
 * @param findings of the file's own checks, those that are wanted
 * @param dropped how many more there are
 * @param suppressions by comments in it
 */
record FileResult(
    FileOutline outline, List<Finding> findings, int dropped, Suppressions suppressions) {}
