/** Tests of finding out about GL. */
@NullMarked
package org.selectiverenderer.render.context;

import org.jspecify.annotations.NullMarked;
