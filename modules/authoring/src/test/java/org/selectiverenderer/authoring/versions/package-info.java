@NullMarked
package org.selectiverenderer.authoring.versions;

import org.jspecify.annotations.NullMarked;
