/** Lists of files that were opened lately. */
@NullMarked
package org.selectiverenderer.app.recent;

import org.jspecify.annotations.NullMarked;
