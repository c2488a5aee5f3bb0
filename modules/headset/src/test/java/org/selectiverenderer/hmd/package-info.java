@NullMarked
package org.selectiverenderer.hmd;

import org.jspecify.annotations.NullMarked;
