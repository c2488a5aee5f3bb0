/** Tests of the threshold pilot. */
@NullMarked
package org.selectiverenderer.study.threshold;

import org.jspecify.annotations.NullMarked;
