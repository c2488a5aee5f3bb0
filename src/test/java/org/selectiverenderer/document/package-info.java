@NullMarked
package org.selectiverenderer.document;

import org.jspecify.annotations.NullMarked;
