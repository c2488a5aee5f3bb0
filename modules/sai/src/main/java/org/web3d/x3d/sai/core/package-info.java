/**
 * Typed access to the nodes of the Core component that the embedded browser acts on. The rule by
 * which methods name fields stands in {@link org.web3d.x3d.sai}; uses nothing but that package.
 */
@NullMarked
package org.web3d.x3d.sai.core;

import org.jspecify.annotations.NullMarked;
