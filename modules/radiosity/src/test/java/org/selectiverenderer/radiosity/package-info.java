/** Tests of radiosity against closed forms, laws and pictures in small. */
@NullMarked
package org.selectiverenderer.radiosity;

import org.jspecify.annotations.NullMarked;
