@NullMarked
package org.selectiverenderer.document.headless;

import org.jspecify.annotations.NullMarked;
