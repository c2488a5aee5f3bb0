/** Tests of how liblsl is found. */
@NullMarked
package org.selectiverenderer.lsl;

import org.jspecify.annotations.NullMarked;
