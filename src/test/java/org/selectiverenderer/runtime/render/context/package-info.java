/** Tests of finding out about GL. */
@NullMarked
package org.selectiverenderer.runtime.render.context;

import org.jspecify.annotations.NullMarked;
