@NullMarked
package org.selectiverenderer.document.file;

import org.jspecify.annotations.NullMarked;
