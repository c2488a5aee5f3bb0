/** Tests of files that are written whole or not at all. */
@NullMarked
package org.selectiverenderer.base.files;

import org.jspecify.annotations.NullMarked;
