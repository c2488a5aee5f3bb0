/** Tests of the recipes of the office. */
@NullMarked
package org.selectiverenderer.apartment.office;

import org.jspecify.annotations.NullMarked;
