/** What the things of the apartment are made of. Uses {@code modelling} only. */
@NullMarked
package org.selectiverenderer.apartment.looks;

import org.jspecify.annotations.NullMarked;
