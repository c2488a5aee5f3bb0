/** Tests of markup. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.base.markup;
