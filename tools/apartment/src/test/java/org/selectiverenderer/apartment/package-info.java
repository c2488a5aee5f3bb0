/** Tests of the apartment as a whole. */
@NullMarked
package org.selectiverenderer.apartment;

import org.jspecify.annotations.NullMarked;
