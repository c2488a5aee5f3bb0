package org.selectiverenderer.testing;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test that makes symbolic links. It is skipped where this user can make none: on Windows without
 * the privilege or the developer mode, and in Wine, which makes an empty file instead.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@ExtendWith(SymbolicLinkCondition.class)
public @interface RequiresSymbolicLinks {}
