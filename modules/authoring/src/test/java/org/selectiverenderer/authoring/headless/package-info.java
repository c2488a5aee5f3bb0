@NullMarked
package org.selectiverenderer.authoring.headless;

import org.jspecify.annotations.NullMarked;
