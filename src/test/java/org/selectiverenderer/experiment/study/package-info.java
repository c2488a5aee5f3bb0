@NullMarked
package org.selectiverenderer.experiment.study;

import org.jspecify.annotations.NullMarked;
