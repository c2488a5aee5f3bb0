/** Tests of the rooms themselves. */
@NullMarked
package org.selectiverenderer.apartment.frame;

import org.jspecify.annotations.NullMarked;
