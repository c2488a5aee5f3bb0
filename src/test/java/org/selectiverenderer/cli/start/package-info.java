/** The commands of the first minute. */
@NullMarked
package org.selectiverenderer.cli.start;

import org.jspecify.annotations.NullMarked;
