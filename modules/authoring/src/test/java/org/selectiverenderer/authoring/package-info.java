@NullMarked
package org.selectiverenderer.authoring;

import org.jspecify.annotations.NullMarked;
