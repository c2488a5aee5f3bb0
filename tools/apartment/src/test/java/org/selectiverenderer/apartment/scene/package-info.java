/** Tests of the scenes' text. */
@NullMarked
package org.selectiverenderer.apartment.scene;

import org.jspecify.annotations.NullMarked;
