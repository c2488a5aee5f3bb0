package org.selectiverenderer.validation.run;

import java.util.List;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.Finding;

/**
 * The result of checking a file by itself.
 *
 * @param findings findings of the file's own checks that are not suppressed
 * @param dropped number of further findings beyond the limit
 * @param suppressions suppressions by comments in the file
 */
record FileCheckResult(
    FileOutline outline, List<Finding> findings, int dropped, Suppressions suppressions) {}
