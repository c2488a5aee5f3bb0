/** Tests of the modelling toolkit. */
@NullMarked
package org.selectiverenderer.modelling;

import org.jspecify.annotations.NullMarked;
