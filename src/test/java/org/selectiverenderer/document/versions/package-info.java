@NullMarked
package org.selectiverenderer.document.versions;

import org.jspecify.annotations.NullMarked;
