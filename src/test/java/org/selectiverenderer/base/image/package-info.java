/** Tests of PNG. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.base.image;
