/** The materials of the apartment's objects. Uses {@code modelling} only. */
@NullMarked
package org.selectiverenderer.apartment.materials;

import org.jspecify.annotations.NullMarked;
