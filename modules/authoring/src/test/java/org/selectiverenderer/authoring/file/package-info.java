@NullMarked
package org.selectiverenderer.authoring.file;

import org.jspecify.annotations.NullMarked;
