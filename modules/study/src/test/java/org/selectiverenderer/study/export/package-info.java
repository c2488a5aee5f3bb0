/** Tests of the exported tables. */
@NullMarked
package org.selectiverenderer.study.export;

import org.jspecify.annotations.NullMarked;
