// SPDX-License-Identifier: MIT
// Lab 10's functions, bound to the student's. Its trees are made out of the contract's here, and the other way round.

#include "contract.hpp"

#include <lab10_hierarchy/hierarchy.hpp>

using namespace contract::lab10;  // found only where the student's header lacks the name

namespace lab10 {

namespace {

namespace plain = contract::lab10;

tree own(const plain::tree& shown) {
    tree t;
    for (const plain::node& n : shown.nodes) t.nodes.push_back({n.box, n.left, n.right, n.first, n.count});
    t.order = shown.order;
    return t;
}

plain::tree shown(const tree& own) {
    plain::tree t;
    for (const node& n : own.nodes) t.nodes.push_back({n.box, n.left, n.right, n.first, n.count});
    t.order = own.order;
    return t;
}

plain::halves shown(const halves& own) { return {own.left, own.right}; }

}  // namespace

const contract::table lab{
    contract::bind<plain::box_around>(box_around),
    contract::bind<plain::at_median>([](boxes_in boxes, group_in group) { return shown(at_median(boxes, group)); }),
    contract::bind<plain::at_middle>([](boxes_in boxes, group_in group) { return shown(at_middle(boxes, group)); }),
    contract::bind<plain::build>([](boxes_in boxes, const plain::splitter& split, std::uint32_t leaf_size, std::uint32_t max_depth) {
        return shown(build(boxes, [&](group_in group) {
            const plain::halves parts = split(group);
            return halves{parts.left, parts.right};
        }, leaf_size, max_depth));
    }),
    contract::bind<plain::cost>([](const plain::tree& t) { return cost(own(t)); }),
    contract::bind<plain::at_least_cost>([](boxes_in boxes, group_in group) { return shown(at_least_cost(boxes, group)); }),
    contract::bind<plain::bottom_up>([](boxes_in boxes) { return shown(bottom_up(boxes)); }),
    contract::bind<plain::traverse>([](const plain::tree& t, lantern::interval range, const plain::enter_box& enter,
                                       const plain::offer_surface& offer) { traverse(own(t), range, enter, offer); }),
    contract::bind<plain::occluded>([](const plain::tree& t, lantern::interval range, const plain::enter_box& enter,
                                       const plain::blocks_ray& blocks) { return occluded(own(t), range, enter, blocks); }),
    contract::bind<plain::refit>([](const plain::tree& t, boxes_in opening, boxes_in closing) { return shown(refit(own(t), opening, closing)); }),
};

}  // namespace lab10
