/** Tests of the thesis's figures as data. */
@NullMarked
package org.selectiverenderer.apartment.facts;

import org.jspecify.annotations.NullMarked;
