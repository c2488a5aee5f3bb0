/** Tests of the rooms themselves. */
@NullMarked
package org.selectiverenderer.apartment.building;

import org.jspecify.annotations.NullMarked;
