/**
 * Typed access to the nodes of the Pointing device sensor component that the embedded browser acts
 * on. The rule by which methods name fields stands in {@link org.web3d.x3d.sai}; uses nothing but
 * that package.
 */
@NullMarked
package org.web3d.x3d.sai.pointingdevicesensor;

import org.jspecify.annotations.NullMarked;
