/** Runs commands on files that were made to harm, from {@code src/test/resources/hostile}. */
@NullMarked
package org.selectiverenderer.cli.hostile;

import org.jspecify.annotations.NullMarked;
