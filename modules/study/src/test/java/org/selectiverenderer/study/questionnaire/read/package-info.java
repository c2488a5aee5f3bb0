@NullMarked
package org.selectiverenderer.study.questionnaire.read;

import org.jspecify.annotations.NullMarked;
