/** Tests of PNG. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.formats.image;
