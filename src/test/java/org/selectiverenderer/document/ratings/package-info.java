@NullMarked
package org.selectiverenderer.document.ratings;

import org.jspecify.annotations.NullMarked;
