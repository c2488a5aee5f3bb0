@NullMarked
package org.selectiverenderer.experiment.questionnaire.read;

import org.jspecify.annotations.NullMarked;
